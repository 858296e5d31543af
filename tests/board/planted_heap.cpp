/// @file  A program with a heap, to see that it is found. Never run.

#include <cstdlib>

extern "C" void* _sbrk(int) { return nullptr; }

int main(int argc, char**) {
  volatile char* memory = static_cast<char*>(std::calloc(1, static_cast<std::size_t>(argc)));
  return memory == nullptr ? 1 : memory[0];
}
