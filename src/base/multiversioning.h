// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that are compiled for wide vectors, too.
#pragma once

// Before a function whose loops have a fixed number of lanes: the widest version that the processor can run
// is chosen when the program starts. All versions give the same bytes, as sums are kept by lane and nothing
// is contracted (cmake/flags.cmake). Such a function is called through a table, so it should do much at once.
// Sanitizers look at what runs before they are ready, so they get the plain version.
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define RIMLINE_WIDE __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
// Before two functions of one name: the first is taken where the processor has AVX-512.
#define RIMLINE_AVX512 __attribute__((target("arch=x86-64-v4")))
#define RIMLINE_OTHERS __attribute__((target("default")))
#else
#define RIMLINE_WIDE
#define RIMLINE_OTHERS
#endif
