s/empty_o || (pop_i \&\& count_o == ONE)/empty_o/
