s/wait_q   <= take_o || command == REFRESH || command == LOAD_MODE/wait_q   <= take_o || command == LOAD_MODE/
