#include "measurements/WitnessSource.hpp"

namespace naocal {

namespace {

/// A marker that was brought into contact with a place: worldFromLink * marker = place.
class Contact final : public Witness {
public:
  Contact(const Measurements& measurements, std::size_t marker, std::size_t place, std::size_t level)
      : Witness{{{0, 3, level}},
                listOwn(measurements.quantities, marker, place),
                measurements.instruments.markers[marker].name},
        marker_{marker}, place_{place} {}

  WitnessRows compare(const RigidTransform& linkFromWorld, const ModelState& modelState) const override {
    const RigidTransform worldFromLink = linkFromWorld.inverse();
    const Eigen::Vector3d marker = modelState.marker(marker_);
    WitnessRows rows{worldFromLink * marker - modelState.place(place_), WitnessRows::ByMotion{3, 6},
                     WitnessRows::ByOwn{3, 6}};
    rows.byMotion << worldFromLink.rotation * crossMatrix(marker), -worldFromLink.rotation;
    rows.byOwn << worldFromLink.rotation, -Eigen::Matrix3d::Identity();
    return rows;
  }

private:
  static std::vector<std::size_t> listOwn(const StateLayout& quantities, std::size_t marker, std::size_t place) {
    std::vector<std::size_t> own;
    for (const std::size_t first : {quantities.marker(marker), quantities.place(place)}) {
      own.insert(own.end(), {first, first + 1, first + 2});
    }
    return own;
  }

  std::size_t marker_, place_;
};

} // namespace

void addContacts(WitnessSource& source) {
  const InstrumentList& known = source.measurements.instruments;
  for (const ContactReading& reading : source.capture.contacts) {
    const std::size_t marker = indexOf(known.markers, source.nameOf(reading.marker)),
                      place = indexOf(known.places, source.nameOf(reading.place));
    const std::size_t level =
        source.level(contactLevel, ReadingLevel::Unit::metres, source.set.instruments.contactSigma, 1e-3);
    source.witnesses.push_back({source.viewOf(known.markers[marker].link, "marker " + reading.marker),
                                std::make_shared<Contact>(source.measurements, marker, place, level)});
  }
}

} // namespace naocal
