#pragma once
// The calls that load a module, on Windows.
#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>
#undef near
#undef far
#define RTLD_NOW 0
#define RTLD_LOCAL 0
inline void* dlopen(const char* path, int) { return LoadLibraryA(path); }
inline void* dlsym(void* module, const char* name) {
  return reinterpret_cast<void*>(GetProcAddress(static_cast<HMODULE>(module), name));
}
inline const char* dlerror() { return "Windows refuses it"; }
