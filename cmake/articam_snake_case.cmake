# articam_snake_case(CamelName out): KitchenDoor -> kitchen_door, LBRArm7 -> lbr_arm7
function(articam_snake_case name out)
  string(REGEX REPLACE "([A-Z]+)([A-Z][a-z])" "\\1_\\2" snake ${name})
  string(REGEX REPLACE "([a-z0-9])([A-Z])" "\\1_\\2" snake ${snake})
  string(TOLOWER ${snake} snake)
  set(${out} ${snake} PARENT_SCOPE)
endfunction()
