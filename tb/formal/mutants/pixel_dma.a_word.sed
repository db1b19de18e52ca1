s/(odd_i || onchip_read_i)/odd_i/
