# clocks.memory_group sleeps
s/memory_wakes_i || fetch_due_i ||/memory_wakes_i ||/
