# What the Cortex-M presets share. The including file says which processor (ARTICAM_CPU_FLAGS) and which machine of
# qemu (ARTICAM_MACHINE) has one. No operating system and no C start-up: hal/baremetal brings its own.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)  # a program needs hal/baremetal's linker script

set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_CXX_FLAGS_INIT "${ARTICAM_CPU_FLAGS} -mthumb -ffunction-sections -fdata-sections")
# The C and mathematics libraries without any of newlib's system calls. There is no _sbrk, so a program that needs a
# heap does not link.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-nostartfiles -nodefaultlibs -Wl,--gc-sections")
set(CMAKE_CXX_STANDARD_LIBRARIES "-Wl,--start-group -lm -lc -lgcc -Wl,--end-group")

# Text and exit code come through semihosting; what the program is given follows as `-append "words"`.
set(CMAKE_CROSSCOMPILING_EMULATOR
  qemu-system-arm -machine ${ARTICAM_MACHINE} -display none -serial none -monitor none
  -chardev stdio,id=text -semihosting-config enable=on,target=native,chardev=text -kernel)

# Headers such as Eigen's are the host's; programs and libraries of the host are of no use.
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
