// SPDX-License-Identifier: Apache-2.0
#include "core/repair/SeriesFindings.h"

#include "core/repair/RepairLattice.h"

#include <algorithm>

namespace core {

namespace {

/// More of them are no parts that anybody looks at one by one.
constexpr std::size_t mostParts = 12;

QString millimetres(double value)
{
    return QString::number(value, 'g', 4);
}

QString sizeInWords(const VolumeGeometry& geometry)
{
    return QStringLiteral("%1 × %2 × %3")
        .arg(geometry.size.x)
        .arg(geometry.size.y)
        .arg(geometry.size.z);
}

RepairOffer offer(const VolumeGeometry& slices, const SeriesRepair& repair)
{
    return {.repair = repair.toText(),
        .series = {},
        .title = {},
        .effect = {},
        .result = repairedGeometry(slices, repair)};
}

RepairOffer tiltOffer(const VolumeGeometry& slices)
{
    RepairOffer tilt = offer(slices, {.tilt = true});
    tilt.title = QStringLiteral("Shear the tilt out");
    const glm::ivec3 grown = tilt.result.size - slices.size;
    QStringList room;
    if (grown.x > 0)
        room +=
            grown.x == 1 ? QStringLiteral("1 column") : QStringLiteral("%1 columns").arg(grown.x);
    if (grown.y > 0)
        room += grown.y == 1 ? QStringLiteral("1 row") : QStringLiteral("%1 rows").arg(grown.y);
    tilt.effect = QStringLiteral(
        "Every slice is shifted in its own plane until all lie straight behind each other; %1"
        "slices lie %2 mm apart.")
                      .arg(room.isEmpty() ? QString()
                                          : QStringLiteral("the picture grows by %1, and ")
                                                .arg(room.join(QStringLiteral(" and "))),
                          millimetres(tilt.result.spacingMm().z));
    return tilt;
}

/// How many of the lattice's slices lie on slices of the source.
int keptSlices(const VolumeGeometry& slices, const SeriesRepair& repair)
{
    const RepairLattice lattice = repairLattice(slices, repair);
    return int(std::count_if(lattice.places.begin(), lattice.places.end(),
        [](const LatticePlace& place) { return place.z % wholeVoxel == 0; }));
}

RepairOffer latticeOffer(const VolumeGeometry& slices, SeriesRepair::Lattice lattice)
{
    const SeriesRepair repair{.lattice = lattice};
    RepairOffer even = offer(slices, repair);
    const int kept = keptSlices(slices, repair);
    const int made = even.result.size.z - kept;
    const QString distance = millimetres(even.result.spacingMm().z);
    if (lattice == SeriesRepair::Lattice::Filled) {
        even.title = made == 1 ? QStringLiteral("Fill the gap") : QStringLiteral("Fill the gaps");
        even.effect = QStringLiteral("%1 interpolated from the neighbouring slices, %2 keep "
                                     "their values; all lie %3 mm apart.")
                          .arg(made == 1 ? QStringLiteral("1 slice is")
                                         : QStringLiteral("%1 slices are").arg(made))
                          .arg(kept)
                          .arg(distance);
    } else {
        even.title = QStringLiteral("Resample to even spacing");
        even.effect = QStringLiteral("%1 slices %2 mm apart, interpolated between the %3 that "
                                     "there are.")
                          .arg(even.result.size.z)
                          .arg(distance)
                          .arg(slices.size.z);
    }
    return even;
}

void offerParts(const VolumeGeometry& slices, std::vector<RepairOffer>& offers)
{
    const std::vector<SlicePart> parts = gapParts(slices);
    if (parts.size() < 2 || parts.size() > mostParts)
        return;
    for (std::size_t index = 0; index < parts.size(); ++index) {
        const SlicePart& part = parts[index];
        RepairOffer only = offer(slices, {.part = int(index) + 1});
        only.title = QStringLiteral("Split: %1 only")
                         .arg(slicesInWords({{part.first + 1, part.first + part.count}}));
        only.effect = QStringLiteral("Part %1 of %2 is opened alone, its voxels as they are.")
                          .arg(index + 1)
                          .arg(parts.size());
        offers.push_back(std::move(only));
    }
}

void offerOnePerPlace(const VolumeGeometry& result, std::vector<RepairOffer>& offers)
{
    using Duplicates = SeriesRepair::Duplicates;
    for (const Duplicates which : {Duplicates::First, Duplicates::Last}) {
        const bool first = which == Duplicates::First;
        offers.push_back({.repair = SeriesRepair{.duplicates = which}.toText(),
            .series = {},
            .title = first ? QStringLiteral("Drop duplicates, keep the first")
                           : QStringLiteral("Drop duplicates, keep the last"),
            .effect = QStringLiteral("Of several images at one place the one with the %1 instance "
                                     "number is taken.")
                          .arg(first ? QStringLiteral("least") : QStringLiteral("greatest")),
            .result = result});
    }
}

std::vector<RepairOffer> offersFor(const VolumeProblem& problem, const VolumeGeometry& slices,
    const std::optional<VolumeGeometry>& undoubled)
{
    std::vector<RepairOffer> offers;
    using Kind = VolumeProblem::Kind;
    switch (problem.kind) {
    case Kind::MissingSlices: {
        // Of pictures only the names tell that one is missing: there is no gap to fill.
        RepairOffer filled = latticeOffer(slices, SeriesRepair::Lattice::Filled);
        if (filled.result.size.z > slices.size.z)
            offers.push_back(std::move(filled));
        offerParts(slices, offers);
        break;
    }
    case Kind::UnevenSpacing:
        offers.push_back(latticeOffer(slices, SeriesRepair::Lattice::Even));
        offerParts(slices, offers);
        break;
    case Kind::Tilt:
        if (repairObstacle(slices, {.tilt = true}).isEmpty())
            offers.push_back(tiltOffer(slices));
        break;
    case Kind::DoubledSlices:
    case Kind::DuplicateSlices:
        if (undoubled)
            offerOnePerPlace(*undoubled, offers);
        break;
    case Kind::MixedSlices:
    case Kind::AssumedSpacing:
    case Kind::DamagedSlice:
    case Kind::LossyCompression:
    case Kind::InexactValues:
    case Kind::Other:
        break;
    }
    return offers;
}

/// What was done; who takes it back is asked again.
RepairOffer givenSpacing(const QString& repair, const VolumeGeometry& geometry)
{
    const glm::dvec3 spacing = geometry.spacingMm();
    return {.repair = repair,
        .series = {},
        .title = QStringLiteral("%1 × %2 × %3 mm")
                     .arg(millimetres(spacing.x), millimetres(spacing.y), millimetres(spacing.z)),
        .effect = QStringLiteral("As given on opening. Opened as it is, it asks for it again."),
        .result = geometry};
}

/// That there are other stacks in the series.
std::optional<SeriesFinding> severalStacks(const SeriesAlternatives& alternatives, int slices)
{
    if (alternatives.stacks.empty())
        return std::nullopt;
    SeriesFinding finding{
        .problem = {.kind = VolumeProblem::Kind::Other,
            .text = QStringLiteral("The series holds %1 stacks; this is %2, of %3 slices.")
                        .arg(alternatives.stacks.size() + 1)
                        .arg(alternatives.part)
                        .arg(slices)}};
    for (const SeriesAlternatives::Stack& stack : alternatives.stacks) {
        finding.offers.push_back({.repair = {},
            .series = stack.key,
            .title = QStringLiteral("Open %1").arg(stack.part),
            .effect = QStringLiteral("Another stack of the series: %1 voxels.")
                          .arg(sizeInWords(stack.geometry)),
            .result = stack.geometry});
    }
    return finding;
}

std::vector<SeriesFinding> findingsOf(const VolumeGeometry& slices,
    const std::vector<VolumeProblem>& problems, const SeriesAlternatives& alternatives)
{
    std::vector<SeriesFinding> findings;
    if (std::optional<SeriesFinding> stacks = severalStacks(alternatives, slices.size.z))
        findings.push_back(*std::move(stacks));
    for (const VolumeProblem& problem : problems)
        findings.push_back(
            {.problem = problem, .offers = offersFor(problem, slices, alternatives.undoubled)});
    return findings;
}

} // namespace

SeriesAlternatives seriesAlternatives(
    const StudyListing& listing, const SeriesEntry& entry, int time)
{
    SeriesAlternatives alternatives{.key = entry.key,
        .part = entry.part,
        .times = entry.times,
        .time = time,
        .undoubled = entry.undoubled};
    if (entry.part.isEmpty())
        return alternatives;
    for (const StudyEntry& study : listing.studies) {
        for (const SeriesEntry& other : study.series) {
            const bool same = !other.identity.seriesUid.isEmpty()
                && other.identity.seriesUid == entry.identity.seriesUid;
            if (same && other.key != entry.key)
                alternatives.stacks.push_back(
                    {.key = other.key, .part = other.part, .geometry = other.geometry});
        }
    }
    return alternatives;
}

std::vector<SeriesFinding> seriesFindings(const StudyListing& listing, const SeriesEntry& entry)
{
    return findingsOf(entry.geometry, entry.problems, seriesAlternatives(listing, entry));
}

std::vector<SeriesFinding> seriesFindings(const Volume& volume)
{
    std::vector<SeriesFinding> findings;
    if (volume.sourceFormat == QLatin1String("DICOM"))
        return findingsOf(volume.asIs ? volume.asIs->geometry : volume.geometry, volume.problems,
            volume.alternatives ? *volume.alternatives : SeriesAlternatives());
    for (const VolumeProblem& problem : volume.problems) {
        findings.push_back({.problem = problem, .offers = {}});
        if (problem.kind == VolumeProblem::Kind::AssumedSpacing && !problem.repairedBy.isEmpty())
            findings.back().offers.push_back(givenSpacing(problem.repairedBy, volume.geometry));
    }
    return findings;
}

} // namespace core
