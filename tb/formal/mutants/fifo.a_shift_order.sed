s/(left == n/(count_o == n/
