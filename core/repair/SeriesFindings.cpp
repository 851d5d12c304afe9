// SPDX-License-Identifier: Apache-2.0
#include "core/repair/SeriesFindings.h"

#include "core/repair/RepairLattice.h"

#include <algorithm>

namespace core {

namespace {

/// More of them are no parts that anybody looks at one by one.
constexpr std::size_t mostParts = 12;

RepairOffer offer(RepairOffer::Kind kind, const VolumeGeometry& slices, const SeriesRepair& repair)
{
    return {.kind = kind, .repair = repair.toText(), .result = repairedGeometry(slices, repair)};
}

RepairOffer tiltOffer(const VolumeGeometry& slices)
{
    RepairOffer tilt = offer(RepairOffer::Kind::ShearTilt, slices, {.tilt = true});
    tilt.columns = tilt.result.size.x - slices.size.x;
    tilt.rows = tilt.result.size.y - slices.size.y;
    return tilt;
}

/// How many of the lattice's slices lie on slices of the source.
int keptSlices(const VolumeGeometry& slices, const SeriesRepair& repair)
{
    const RepairLattice lattice = repairLattice(slices, repair);
    return int(std::count_if(lattice.places.begin(), lattice.places.end(),
        [](const LatticePlace& place) { return place.z % wholeVoxel == 0; }));
}

RepairOffer fillOffer(const VolumeGeometry& slices)
{
    const SeriesRepair repair{.lattice = SeriesRepair::Lattice::Filled};
    RepairOffer fill = offer(RepairOffer::Kind::FillGaps, slices, repair);
    fill.kept = keptSlices(slices, repair);
    fill.made = fill.result.size.z - fill.kept;
    return fill;
}

RepairOffer evenOffer(const VolumeGeometry& slices)
{
    RepairOffer even =
        offer(RepairOffer::Kind::EvenSpacing, slices, {.lattice = SeriesRepair::Lattice::Even});
    even.kept = slices.size.z;
    return even;
}

void offerParts(const VolumeGeometry& slices, std::vector<RepairOffer>& offers)
{
    const std::vector<SliceRun> parts = gapParts(slices);
    if (parts.size() < 2 || parts.size() > mostParts)
        return;
    for (std::size_t index = 0; index < parts.size(); ++index) {
        const SliceRun& part = parts[index];
        RepairOffer only = offer(RepairOffer::Kind::Part, slices, {.part = int(index) + 1});
        only.first = part.first + 1;
        only.last = part.first + part.count;
        only.part = int(index) + 1;
        only.parts = int(parts.size());
        offers.push_back(std::move(only));
    }
}

void offerOnePerPlace(const VolumeGeometry& result, std::vector<RepairOffer>& offers)
{
    using Duplicates = SeriesRepair::Duplicates;
    for (const Duplicates which : {Duplicates::First, Duplicates::Last}) {
        offers.push_back({.kind = which == Duplicates::First ? RepairOffer::Kind::FirstDuplicates
                                                             : RepairOffer::Kind::LastDuplicates,
            .repair = SeriesRepair{.duplicates = which}.toText(),
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
        RepairOffer filled = fillOffer(slices);
        if (filled.result.size.z > slices.size.z)
            offers.push_back(std::move(filled));
        offerParts(slices, offers);
        break;
    }
    case Kind::UnevenSpacing:
        offers.push_back(evenOffer(slices));
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
    return {.kind = RepairOffer::Kind::GivenSpacing, .repair = repair, .result = geometry};
}

/// That there are other stacks in the series.
std::optional<SeriesFinding> severalStacks(const SeriesAlternatives& alternatives, int slices)
{
    if (alternatives.stacks.empty())
        return std::nullopt;
    SeriesFinding finding{
        .problem = {.kind = VolumeProblem::Kind::Other,
            .said = {ProblemCode::SeveralStacks,
                {std::int64_t(alternatives.stacks.size()) + 1, alternatives.part, slices}}}};
    for (const SeriesAlternatives::Stack& stack : alternatives.stacks) {
        finding.offers.push_back({.kind = RepairOffer::Kind::OtherStack,
            .series = stack.key,
            .result = stack.geometry,
            .stack = stack.part});
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
