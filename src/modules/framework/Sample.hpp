#pragma once

#include "framework/History.hpp"
#include "framework/Latest.hpp"

#include <concepts>
#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace naocal {

/// A picture as the debug socket sends it.
struct EncodedPicture {
  std::uint16_t width = 0, height = 0; // [px]
  std::string bytes;                   // a JPEG or PNG file
};

/// A type that is shown as a picture: `toPicture` is declared beside it.
template <class T>
concept ShownAsPicture = requires(const T& value) {
  { toPicture(value) } -> std::same_as<EncodedPicture>;
};

/// A copy of a production as it was in one cycle. The cycle only copies; whoever shows it turns it into text.
class Sample {
public:
  virtual ~Sample() = default;
  /// The value through its type's `to_json`; null for a picture.
  virtual void json(nlohmann::json& out) const = 0;
  /// Absent for what is no picture.
  virtual std::optional<EncodedPicture> picture() const = 0;
};

template <class T> class SampleOf final : public Sample {
public:
  explicit SampleOf(const T& value) : value_{value} {}
  void json(nlohmann::json& out) const override {
    if constexpr (!ShownAsPicture<T>) {
      out = value_;
    }
  }
  std::optional<EncodedPicture> picture() const override {
    if constexpr (ShownAsPicture<T>) {
      return toPicture(value_);
    } else {
      return std::nullopt;
    }
  }

private:
  T value_;
};

/// How a production's value is copied for showing: nullptr where there is nothing to show.
template <class T> std::unique_ptr<const Sample> sampleOf(const T& value) {
  return std::make_unique<SampleOf<T>>(value);
}
template <class T, std::size_t Capacity> std::unique_ptr<const Sample> sampleOf(const History<T, Capacity>& history) {
  const auto entry = history.newest();
  return entry ? std::make_unique<SampleOf<T>>(entry->value) : nullptr;
}
template <class T> std::unique_ptr<const Sample> sampleOf(const Latest<T>&) {
  return nullptr;
}

/// What is handed over belongs to its reader, and is not shown.
template <class T> inline constexpr bool isShown = true;
template <class T> inline constexpr bool isShown<Latest<T>> = false;

} // namespace naocal
