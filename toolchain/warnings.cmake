# articam::strict: our own code compiles without a warning.
add_library(articam_strict INTERFACE)
add_library(articam::strict ALIAS articam_strict)
target_compile_options(articam_strict INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion -Wnon-virtual-dtor -Werror)
