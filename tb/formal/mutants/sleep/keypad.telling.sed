s/ || telling$//
