# 32-bit ARM boards under Linux (ARMv7 with hardware floating point): Debian's armhf.
set(CMAKE_SYSTEM_PROCESSOR armv7l)
set(ARTICAM_TRIPLET arm-linux-gnueabihf)
set(ARTICAM_EMULATOR qemu-arm)
set(ARTICAM_TARGET_NAME armhf)  # in tests/board/ceilings.txt
cmake_path(SET default NORMALIZE ${CMAKE_CURRENT_LIST_DIR}/../build/sysroot-armhf)
set(ARTICAM_SYSROOT ${default} CACHE PATH "Libraries of the board")
include(${CMAKE_CURRENT_LIST_DIR}/linux_cross.cmake)
