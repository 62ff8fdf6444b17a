// A plug-in of another build that needs what this program lacks: its stamp tells, not the linker.
extern "C" const char* hawser_plugin_stamp() { return "hawser-abi-0/gcc-4.0.0"; }
extern void hawser_of_long_ago();
extern "C" void hawser_plugin_register() { hawser_of_long_ago(); }
