#pragma once

/// Marks the definition of a function that ricochet.h declares.
#define RICOCHET_EXPORTED extern "C" __attribute__((visibility("default")))
