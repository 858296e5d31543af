# Cortex-M3, without a floating-point unit: float and double are computed by libgcc.
set(ARTICAM_CPU_FLAGS "-mcpu=cortex-m3 -mfloat-abi=soft")
set(ARTICAM_TARGET_NAME cortex-m3)  # in tests/board/ceilings.txt
set(ARTICAM_SOFTWARE_DOUBLE ON)
set(ARTICAM_MACHINE mps2-an385)
include(${CMAKE_CURRENT_LIST_DIR}/bare_metal.cmake)
