# A Linux board with another processor: Debian's cross compiler, the board's libraries in a folder of their own
# (tools/cross_sysroot.sh makes it), tests run by qemu's user emulation. Included by a board's toolchain file, after
#   ARTICAM_TRIPLET   the compiler's prefix, which is also Debian's name of the library folders
#   ARTICAM_EMULATOR  the program that runs the board's programs here
#   ARTICAM_SYSROOT   the folder of libraries
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_C_COMPILER ${ARTICAM_TRIPLET}-gcc)
set(CMAKE_CXX_COMPILER ${ARTICAM_TRIPLET}-g++)

if(NOT EXISTS ${ARTICAM_SYSROOT}/.packages)
  message(FATAL_ERROR "No board libraries in ${ARTICAM_SYSROOT}: run tools/setup_cross.sh, or set ARTICAM_SYSROOT")
endif()
# The C and C++ libraries are the cross compiler's own, which looks there first; all others come from the folder.
set(CMAKE_SYSROOT ${ARTICAM_SYSROOT})
set(CMAKE_CROSSCOMPILING_EMULATOR ${ARTICAM_EMULATOR} -L ${ARTICAM_SYSROOT})
# try_compile reads this file anew and knows only the variables named here.
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES ARTICAM_SYSROOT)

# Programs that help to build run here; nothing of this machine may be linked into what runs there.
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(ENV{PKG_CONFIG_PATH} "")
set(ENV{PKG_CONFIG_SYSROOT_DIR} ${ARTICAM_SYSROOT})
set(ENV{PKG_CONFIG_LIBDIR}
    ${ARTICAM_SYSROOT}/usr/lib/${ARTICAM_TRIPLET}/pkgconfig:${ARTICAM_SYSROOT}/usr/share/pkgconfig)
