#pragma once
// Two binaries fit together when this text is the same in both.

// Raised whenever a class that plug-ins see changes its layout.
#define HAWSER_ABI_VERSION "14"
#define HAWSER_ABI_STAMP "hawser-abi-" HAWSER_ABI_VERSION "/gcc-" __VERSION__
