/// @file  A plugin of qemu that counts the instructions between two functions which the program calls as marks.
///
///   -plugin instruction_counter.so,begin=0xADDRESS,end=0xADDRESS,out=FILE
///
/// Writes one count a line, for each time that `end` was reached after `begin`. No interrupt runs between them, so a
/// count repeats to the instruction. The prototypes stand here because no package has qemu's header.
/// Source  QEMU 7.2, include/qemu/qemu-plugin.h, API version 1.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

extern "C" {
using PluginId = std::uint64_t;
struct qemu_plugin_tb;
struct qemu_plugin_insn;
void qemu_plugin_register_vcpu_tb_trans_cb(PluginId, void (*)(PluginId, qemu_plugin_tb*));
void qemu_plugin_register_vcpu_insn_exec_cb(qemu_plugin_insn*, void (*)(unsigned, void*), int flags, void* data);
void qemu_plugin_register_vcpu_insn_exec_inline(qemu_plugin_insn*, int operation, void* counter, std::uint64_t add);
std::size_t qemu_plugin_tb_n_insns(const qemu_plugin_tb*);
qemu_plugin_insn* qemu_plugin_tb_get_insn(const qemu_plugin_tb*, std::size_t);
std::uint64_t qemu_plugin_insn_vaddr(const qemu_plugin_insn*);

extern int qemu_plugin_version;
int qemu_plugin_version = 1;
int qemu_plugin_install(PluginId, const void* machine, int argc, char** argv);
}

namespace {

constexpr int kNoRegisters = 0, kAdd = 0;  // QEMU_PLUGIN_CB_NO_REGS, QEMU_PLUGIN_INLINE_ADD_U64

std::uint64_t begin_address, end_address, executed, at_begin;
std::FILE* out;

void begin(unsigned, void*) { at_begin = executed; }
void end(unsigned, void*) {
  std::fprintf(out, "%llu\n", static_cast<unsigned long long>(executed - at_begin));
  std::fflush(out);
}

void translate(PluginId, qemu_plugin_tb* block) {
  for (std::size_t i = 0; i < qemu_plugin_tb_n_insns(block); ++i) {
    qemu_plugin_insn* instruction = qemu_plugin_tb_get_insn(block, i);
    const std::uint64_t address = qemu_plugin_insn_vaddr(instruction);
    if (address == begin_address) qemu_plugin_register_vcpu_insn_exec_cb(instruction, begin, kNoRegisters, nullptr);
    if (address == end_address) qemu_plugin_register_vcpu_insn_exec_cb(instruction, end, kNoRegisters, nullptr);
    qemu_plugin_register_vcpu_insn_exec_inline(instruction, kAdd, &executed, 1);
  }
}

}  // namespace

int qemu_plugin_install(PluginId id, const void*, int argc, char** argv) {
  for (int i = 0; i < argc; ++i) {
    const std::string_view argument{argv[i]};
    if (argument.starts_with("begin=")) begin_address = std::strtoull(argv[i] + 6, nullptr, 16);
    if (argument.starts_with("end=")) end_address = std::strtoull(argv[i] + 4, nullptr, 16);
    if (argument.starts_with("out=")) out = std::fopen(argv[i] + 4, "w");
  }
  if (begin_address == 0 || end_address == 0 || out == nullptr) {
    std::fputs("instruction_counter: begin=0xADDRESS,end=0xADDRESS,out=FILE are wanted\n", stderr);
    return 1;
  }
  qemu_plugin_register_vcpu_tb_trans_cb(id, translate);
  return 0;
}
