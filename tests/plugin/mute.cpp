// A shared library that is no plug-in.
extern "C" int hawser_mute() { return 0; }
