#include "link/datagram_guard.hpp"

#include <linux/filter.h>
#include <linux/if_packet.h>
#include <net/if.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "link/receive_socket.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille::bus {
namespace {

/// A program for the kernel's packet filter. It sees a datagram from its UDP header on; a load past
/// the end drops the datagram.
class Program {
 public:
  static constexpr std::uint32_t kUdpHeader = 8;

  /// Loads 1, 2 or 4 bytes of the payload.
  void load(int bytes, std::uint32_t at) {
    load_raw(bytes == 1 ? BPF_B : bytes == 2 ? BPF_H : BPF_W, kUdpHeader + at);
  }
  void load_raw(int size, std::uint32_t at) { add(BPF_LD | size | BPF_ABS, at); }
  void mask(std::uint32_t value) { add(BPF_ALU | BPF_AND | BPF_K, value); }
  void keep_in_x() { add(BPF_MISC | BPF_TAX, 0); }

  void drop() { add(BPF_RET | BPF_K, 0); }
  void accept() { add(BPF_RET | BPF_K, 0xffffffff); }
  /// These accept or drop the datagram if the loaded value is equal to, or greater than, a value.
  void accept_if_equal(std::uint32_t value) { return_if(BPF_JEQ | BPF_K, value, 0xffffffff); }
  void drop_if_greater(std::uint32_t value) { return_if(BPF_JGT | BPF_K, value, 0); }
  void drop_if_greater_than_x() { return_if(BPF_JGT | BPF_X, 0, 0); }

  /// Jumps, if the loaded value equals `value`, to the position at which mark() is called later.
  void jump_if_equal(std::uint32_t value, std::vector<std::size_t>* to) {
    code_.push_back({BPF_JMP | BPF_JEQ | BPF_K, 0, 1, value});
    to->push_back(code_.size());
    add(BPF_JMP | BPF_JA, 0);
  }
  void mark(const std::vector<std::size_t>& from) {
    for (const std::size_t jump : from) {
      code_[jump].k = static_cast<std::uint32_t>(code_.size() - jump - 1);
    }
  }

  void attach(int socket) {
    const sock_fprog program = {static_cast<unsigned short>(code_.size()), code_.data()};
    if (setsockopt(socket, SOL_SOCKET, SO_ATTACH_FILTER, &program, sizeof program) == 0) return;
    throw std::runtime_error(std::string("the kernel refuses a filter for LCM's socket: ") +
                             std::strerror(errno));
  }

 private:
  void add(int operation, std::uint32_t value) {
    code_.push_back({static_cast<std::uint16_t>(operation), 0, 0, value});
  }
  void return_if(int comparison, std::uint32_t value, std::uint32_t verdict) {
    code_.push_back({static_cast<std::uint16_t>(BPF_JMP | comparison), 0, 1, value});
    add(BPF_RET | BPF_K, verdict);
  }

  std::vector<sock_filter> code_;
};

constexpr std::uint32_t kShortMagic = 0x4c433032, kLongMagic = 0x4c433033;
constexpr std::uint32_t kShortHeader = 8, kLongHeader = 20;
/// Length of the longest channel name that LCM accepts, and size of its largest message [byte].
constexpr std::uint32_t kMaxChannel = 63, kMaxMessage = 1u << 28;

/// Accepts a datagram if the channel name that begins at an offset is terminated, and drops it
/// otherwise.
void accept_with_channel(std::uint32_t at, Program* program) {
  for (std::uint32_t i = 0; i <= kMaxChannel; ++i) {
    program->load(1, at + i);
    program->accept_if_equal(0);
  }
  program->drop();
}

/// Accepts fragments that lie within their message. LCM adds a fragment's offset and size in 32
/// bits and compares the sum with the message's size.
void accept_sound_fragments(Program* program) {
  std::vector<std::size_t> first, sound;
  program->load(1, kLongHeader - 1);
  program->load(4, 8);
  program->drop_if_greater(kMaxMessage);
  program->keep_in_x();
  program->load(4, 12);
  program->drop_if_greater_than_x();
  program->load(2, 16);
  program->jump_if_equal(0, &first);
  program->accept();
  program->mark(first);
  program->load(4, 12);
  program->jump_if_equal(0, &sound);
  program->drop();
  program->mark(sound);
  accept_with_channel(kLongHeader, program);
}

void accept_sound_datagrams(Program* program) {
  std::vector<std::size_t> is_short, is_long;
  program->load(4, 0);
  program->jump_if_equal(kShortMagic, &is_short);
  program->jump_if_equal(kLongMagic, &is_long);
  program->drop();
  program->mark(is_short);
  accept_with_channel(kShortHeader, program);
  program->mark(is_long);
  accept_sound_fragments(program);
}

std::uint32_t index_of(const std::string& interface) {
  const unsigned index = if_nametoindex(interface.c_str());
  if (index > 0) return index;
  throw std::runtime_error("no interface '" + printable(interface) +
                           "' to accept senders from; see: ip -brief link");
}

constexpr std::uint32_t ancillary(int what) {
  return static_cast<std::uint32_t>(SKF_AD_OFF + what);
}

void drop_strangers(const AcceptedSenders& senders, Program* program) {
  std::vector<std::size_t> accepted;
  program->load_raw(BPF_W, ancillary(SKF_AD_PKTTYPE));
  program->jump_if_equal(PACKET_LOOPBACK, &accepted);
  program->load_raw(BPF_W, ancillary(SKF_AD_IFINDEX));
  program->jump_if_equal(index_of("lo"), &accepted);
  for (const std::string& interface : senders.interfaces) {
    program->jump_if_equal(index_of(interface), &accepted);
  }
  constexpr int kSourceAddress = 12;
  for (const auto& network : senders.networks) {
    program->load_raw(BPF_W, static_cast<std::uint32_t>(SKF_NET_OFF + kSourceAddress));
    program->mask(network.mask);
    program->jump_if_equal(network.address, &accepted);
  }
  program->drop();
  program->mark(accepted);
}

}  // namespace

void guard_socket(int socket, const AcceptedSenders& senders) {
  Program program;
  if (!senders.all) drop_strangers(senders, &program);
  accept_sound_datagrams(&program);
  program.attach(socket);
}

}  // namespace quadrille::bus
