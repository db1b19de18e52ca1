s/for (n = PARTS - 1; n >= 0; n = n - 1)/for (n = 0; n < PARTS; n = n + 1)/
