// sc_main.cpp - libsystemc wants one; tests elaborate from GoogleTest's main instead.

extern "C" int sc_main(int, char**) { return 0; }
