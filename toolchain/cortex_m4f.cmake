# Cortex-M4 with a floating-point unit for float alone: double is computed by libgcc.
set(ARTICAM_CPU_FLAGS "-mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mfloat-abi=hard")
set(ARTICAM_TARGET_NAME cortex-m4f)  # in tests/board/ceilings.txt
set(ARTICAM_SOFTWARE_DOUBLE ON)
set(ARTICAM_MACHINE mps2-an386)
include(${CMAKE_CURRENT_LIST_DIR}/bare_metal.cmake)
