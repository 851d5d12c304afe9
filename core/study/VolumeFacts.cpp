// SPDX-License-Identifier: Apache-2.0
#include "core/study/VolumeFacts.h"

#include "core/base/Sha256.h"
#include "core/repair/SeriesRepair.h"
#include "core/volume/encoding/VolumeEncoder.h"

#include <algorithm>

namespace core {

namespace {

void add(VolumeFacts& facts, int time, const Volume& volume)
{
    facts.minimum = std::min(facts.minimum, volume.minimum);
    facts.maximum = std::max(facts.maximum, volume.maximum);
    facts.times.push_back({.key = facts.entry.keyAtTime(time),
        .label = facts.entry.times[time],
        .minimum = volume.minimum,
        .maximum = volume.maximum,
        .voxelsSha256 = volume.voxelsSha256});
}

} // namespace

VolumeFacts volumeFacts(const Study& study, const SeriesEntry& entry, const QString& repair)
{
    VolumeFacts facts{
        .entry = entry, .repair = repair, .loaded = study.load(withRepair(entry.key, repair))};
    if (!facts.loaded)
        return facts;
    const Volume& first = facts.loaded->volume;
    facts.minimum = first.minimum;
    facts.maximum = first.maximum;
    facts.voxelsSha256 = first.voxelsSha256;
    if (entry.times.isEmpty())
        return facts;

    Sha256 hash;
    bool follow = first.codesSha256.isEmpty();
    if (follow)
        addValues(hash, *facts.loaded);
    add(facts, 0, first);
    for (int time = 1; time < int(entry.times.size()); ++time) {
        Result<LoadedVolume> later = study.load(withRepair(entry.keyAtTime(time), repair));
        if (!later) {
            facts.loaded = std::move(later);
            return facts;
        }
        add(facts, time, later->volume);
        follow = follow && later->volume.codesSha256.isEmpty();
        if (follow)
            addValues(hash, *later);
    }
    facts.voxelsSha256 = follow ? hash.takeHex() : QByteArray();
    return facts;
}

} // namespace core
