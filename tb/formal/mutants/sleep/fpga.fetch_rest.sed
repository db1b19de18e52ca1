# rests
s/least(beam_rest_i, fetch_rest_i)/beam_rest_i/
