/// \file
/// A list of a few entries, without memory of its own on the heap.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace cleft::enrichment {

/// Three entries for a triangle, seven where the branch functions of a tip reach it. Behaves as a std::array whose size
/// is known at run time; entries beyond the size are unspecified.
template <class T>
class InlinedVector {
 public:
  static constexpr std::size_t kCapacity = 7;

  InlinedVector() : entries_{} {}
  template <std::size_t count>
  InlinedVector(const std::array<T, count>& entries) : entries_{}, size_(count) {  // NOLINT: an array is such a list
    static_assert(count <= kCapacity);
    for (std::size_t k = 0; k < count; ++k) entries_[k] = entries[k];
  }

  std::size_t size() const { return size_; }
  T& operator[](std::size_t k) { return entries_[k]; }
  const T& operator[](std::size_t k) const { return entries_[k]; }
  const T* begin() const { return entries_.data(); }
  const T* end() const { return entries_.data() + size_; }

 private:
  std::array<T, kCapacity> entries_;
  std::uint32_t size_ = 3;
};

}  // namespace cleft::enrichment
