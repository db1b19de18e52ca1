s/empty_o = count_o == .*/empty_o = count_o == ONE;/
