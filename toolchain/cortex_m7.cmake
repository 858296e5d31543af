# Cortex-M7 with a floating-point unit for float and double.
set(ARTICAM_CPU_FLAGS "-mcpu=cortex-m7 -mfpu=fpv5-d16 -mfloat-abi=hard")
set(ARTICAM_TARGET_NAME cortex-m7)  # in tests/board/ceilings.txt
set(ARTICAM_MACHINE mps2-an500)
include(${CMAKE_CURRENT_LIST_DIR}/bare_metal.cmake)
