s/(data || others)/data/
