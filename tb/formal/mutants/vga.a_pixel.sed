s/if (pixel_o) half_q <= place\[0\]/if (pixel_o) half_q <= h[1]/
