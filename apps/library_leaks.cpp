// Memory that libraries never free is not a leak of ours: the CAD kernels, and fontconfig, whose patterns LeakSanitizer
// cannot follow. It asks the program for these by name; builds without it never call them.
extern "C" const char* __lsan_default_options();
extern "C" const char* __lsan_default_options() {
    return "print_suppressions=0";
}

extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libTK\nleak:libgmsh\nleak:libfontconfig\n";
}
