s/wdata_i\[TO\*next +: TO\]/wdata_i[TO-1:0]/
