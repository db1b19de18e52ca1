# leaps
s/30'd1 + {20'd0, skip_i}/{20'd0, skip_i}/
