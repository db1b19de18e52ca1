s/rerror_i ? DECERR : OKAY/OKAY/
