s/{run_q ? left : due_q, phase_q}/{due_q, phase_q}/
