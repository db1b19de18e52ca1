# parts.cmake - Verilator's C++ under names that are known before it is made
#
# cmake -DMADE=folder -DPARTS=n -P parts.cmake
#
# How many files Verilator makes of fpga, and their names, follow from the netlist.  This writes
# fast_1.cpp to fast_n.cpp, which include those that run each clock, and slow.cpp with the others.

include(${MADE}/Vfpga.cmake)

function(write_part name)
    set(text)
    foreach(file ${ARGN})
        get_filename_component(file ${file} NAME)
        string(APPEND text "#include \"${file}\"\n")
    endforeach()
    file(WRITE ${MADE}/${name}.cpp "${text}")
endfunction()

set(part 0)
foreach(file ${Vfpga_CLASSES_FAST} ${Vfpga_SUPPORT_FAST})
    math(EXPR part "${part} % ${PARTS} + 1")
    list(APPEND fast_${part} ${file})
endforeach()
foreach(part RANGE 1 ${PARTS})
    write_part(fast_${part} ${fast_${part}})
endforeach()
write_part(slow ${Vfpga_CLASSES_SLOW} ${Vfpga_SUPPORT_SLOW})
