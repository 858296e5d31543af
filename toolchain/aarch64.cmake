# 64-bit ARM boards under Linux (Raspberry Pi 3 and later, Jetson): Debian's arm64.
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(ARTICAM_TRIPLET aarch64-linux-gnu)
set(ARTICAM_EMULATOR qemu-aarch64)
cmake_path(SET default NORMALIZE ${CMAKE_CURRENT_LIST_DIR}/../build/sysroot-aarch64)
set(ARTICAM_SYSROOT ${default} CACHE PATH "Libraries of the board")
include(${CMAKE_CURRENT_LIST_DIR}/linux_cross.cmake)
