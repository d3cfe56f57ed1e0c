#include "cleft/results/checkpoint.hpp"

#include <zlib.h>

#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace cleft::results {
namespace {

constexpr char kMagic[] = "cleft checkpoint 13\n";

struct Writer {
  std::string out;
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void operator()(T& value) { out.append(reinterpret_cast<const char*>(&value), sizeof value); }
  void size(std::uint64_t& n) { (*this)(n); }
  void raw(void* data, std::size_t bytes) { out.append(static_cast<const char*>(data), bytes); }
};

struct Reader {
  const std::string& in;
  std::size_t at = 0;
  void raw(void* data, std::size_t bytes) {
    if (bytes > in.size() - at) throw std::out_of_range("checkpoint");
    if (bytes > 0) std::memcpy(data, in.data() + at, bytes);
    at += bytes;
  }
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void operator()(T& value) { raw(&value, sizeof value); }
  void size(std::uint64_t& n) {
    (*this)(n);
    if (n > in.size()) throw std::out_of_range("checkpoint");  // no array has more entries than the file has bytes
  }
};

template <class Io>
void pass(Io& io, std::string& text) {
  std::uint64_t n = text.size();
  io.size(n);
  text.resize(n);
  io.raw(text.data(), n);
}

template <class Io>
void pass(Io& io, VecX& v) {
  std::uint64_t n = static_cast<std::uint64_t>(v.size());
  io.size(n);
  v.resize(static_cast<Eigen::Index>(n));
  io.raw(v.data(), n * sizeof(double));
}

template <class Io, class T, class Each>
void pass(Io& io, std::vector<T>& list, Each&& each) {
  std::uint64_t n = list.size();
  io.size(n);
  list.resize(n);
  for (T& item : list) each(item);
}

template <class Io>
void pass(Io& io, growth::Record& g) {
  pass(io, g.points, [&](std::vector<Vec2>& points) { pass(io, points, [&](Vec2& p) { io(p.x()), io(p.y()); }); });
  pass(io, g.s_first, io);
  pass(io, g.tips, [&](std::array<growth::Record::Tip, 2>& ends) {
    for (auto& tip : ends) io(tip.advances), io(tip.stop);
  });
  pass(io, g.pending, [&](growth::PendingAdvance& due) {
    io(due.tip);
    io(due.demand.ratio);
    io(due.demand.ahead.x());
    io(due.demand.ahead.y());
    io(due.demand.stress);
    io(due.demand.intensities);
    io(due.demand.elements);
  });
  io(g.ratio);
  io(g.beyond);
  io(g.ratio_beyond);
}

template <class Io>
void pass(Io& io, contact::ContactState& m) {
  io(m.anchor_face);
  io(m.anchor_place);
  io(m.state.slip);
  io(m.normal);
  io(m.tangential);
  io(m.ramp);
  io(m.slope);
}

template <class Io>
void pass(Io& io, contact::MultiplierState& multipliers) {
  pass(io, multipliers.status, io);
  pass(io, multipliers.multiplier);
  pass(io, multipliers.mismatch);
  pass(io, multipliers.coverage, io);
  pass(io, multipliers.slope, io);
  pass(io, multipliers.smooth, io);
  io(multipliers.stored);
  pass(io, multipliers.state, [&](contact::InterfaceState& state) { io(state.slip); });
  pass(io, multipliers.anchor_maps, [&](contact::AnchorMap& t) {
    io(t.face);
    io(t.begin);
    io(t.end);
    io(t.anchor_face);
    io(t.anchor_begin);
    io(t.anchor_end);
  });
}

template <class Io>
void pass(Io& io, assembly::History& history) {
  pass(io, history.contact, [&](contact::ContactState& m) { pass(io, m); });
  io(history.deepest);
  pass(io, history.plastic, [&](constitutive::PlasticState& p) {
    io(p.deformation);
    io(p.accumulated);
  });
  pass(io, history.multipliers);
}

template <class Io>
void pass(Io& io, assembly::State& s) {
  io(s.load);
  pass(io, s.displacement);
  pass(io, s.history);
  io(s.energies);
  pass(io, s.prescribed_force);
  io(s.largest_force);
  io(s.previous_load);
  pass(io, s.previous_displacement);
  pass(io, s.previous_prescribed_force);
  pass(io, s.progress);
}

template <class Io>
void pass(Io& io, solve::StepPlace& place) {
  io(place.number);
  io(place.step);
  io(place.arc_increment);
  io(place.furthest);
  io(place.longest);
  io(place.plateau);
  io(place.wandered);
}

template <class Io>
void pass(Io& io, Counts& counts) {
  io(counts.iterations);
  io(counts.cuts);
  io(counts.worst_residual);
  io(counts.rounded);
  io(counts.jumps);
}

template <class Io>
void pass(Io& io, std::map<std::string, std::uint64_t>& bytes) {
  std::vector<std::pair<std::string, std::uint64_t>> list(bytes.begin(), bytes.end());
  pass(io, list, [&](auto& entry) {
    pass(io, entry.first);
    io(entry.second);
  });
  bytes = {list.begin(), list.end()};
}

// One function for both ways, so that they cannot differ.
template <class Io>
void pass(Io& io, Checkpoint& c) {
  pass(io, c.scene);
  pass(io, c.state);
  pass(io, c.place);
  pass(io, c.reserved, [&](std::vector<Index>& faces) { pass(io, faces, io); });
  pass(io, c.growth);
  pass(io, c.counts);
  c.counts.increments = c.place.number;
  io(c.seconds);
  pass(io, c.log_bytes);
  pass(io, c.outputs, [&](PvdEntry& entry) {
    io(entry.load);
    io(entry.part);
    pass(io, entry.file);
  });
}

std::uint32_t checksum(const char* data, std::size_t size) {
  return static_cast<std::uint32_t>(crc32(0L, reinterpret_cast<const Bytef*>(data), static_cast<uInt>(size)));
}

}  // namespace

std::string to_bytes(const Checkpoint& checkpoint) {
  Writer writer{kMagic};
  Checkpoint copy = checkpoint;
  pass(writer, copy);
  std::uint32_t sum = checksum(writer.out.data(), writer.out.size());
  writer(sum);
  return writer.out;
}

Checkpoint checkpoint_from(const std::string& bytes, const std::string& path) {
  const std::size_t magic = sizeof kMagic - 1;
  if (bytes.compare(0, magic, kMagic) != 0)
    throw std::runtime_error(path + ": not a checkpoint of this version of cleft");
  std::uint32_t sum = 0;
  if (bytes.size() >= magic + sizeof sum) std::memcpy(&sum, bytes.data() + bytes.size() - sizeof sum, sizeof sum);
  if (bytes.size() < magic + sizeof sum || sum != checksum(bytes.data(), bytes.size() - sizeof sum))
    throw std::runtime_error(path + ": the checkpoint is damaged");
  Reader reader{bytes, magic};
  Checkpoint out;
  try {
    pass(reader, out);
  } catch (const std::out_of_range&) {
    throw std::runtime_error(path + ": the checkpoint is damaged");
  }
  return out;
}

}  // namespace cleft::results
