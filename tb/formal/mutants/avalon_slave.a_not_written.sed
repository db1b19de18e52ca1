s/= runs \&\& known;/= runs;/
