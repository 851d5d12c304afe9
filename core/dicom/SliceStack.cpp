// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/SliceStack.h"

#include "core/dicom/DicomText.h"
#include "core/dicom/StackGeometry.h"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

namespace core {

namespace {

using Images = std::vector<ImageHeader>;

/// Images of a stack at one position.
struct Place {
    double along = 0.0;
    Images images{};
};

QString apartKind(const ImageHeader& image, QString& reason)
{
    if (image.frames > 1 || image.isEnhanced) {
        reason = image.frames == 1
            ? QStringLiteral("a place given frame by frame is not read yet")
            : QStringLiteral("%1 frames in one file are not read yet").arg(image.frames);
        return QStringLiteral("multi-frame image");
    }
    const QString& photometric = image.layout.photometric;
    if (image.layout.samplesPerPixel != 1
        || !(photometric.isEmpty() || photometric.startsWith(QLatin1String("MONOCHROME")))) {
        reason = photometric;
        return QStringLiteral("colour image");
    }
    const QString type = image.imageType.join(QLatin1Char('\\'));
    reason = type;
    for (const char* word : {"LOCALIZER", "SCOUT", "TOPOGRAM", "SURVIEW", "SCANOSCOPE"}) {
        if (type.contains(QLatin1String(word)))
            return QStringLiteral("localizer");
    }
    if (type.contains(QLatin1String("MOSAIC"))) {
        reason = QStringLiteral("many slices tiled in one image");
        return QStringLiteral("mosaic");
    }
    if (!image.position || !image.plane) {
        reason = QStringLiteral("no position or orientation in the patient");
        return QStringLiteral("image without a place");
    }
    if (!image.spacing) {
        reason = QStringLiteral("no pixel spacing");
        return QStringLiteral("image without a scale");
    }
    reason.clear();
    return {};
}

void putApart(std::vector<ForeignObject>& foreign, const ImageHeader& image, const QString& kind,
    const QString& reason)
{
    for (ForeignObject& object : foreign) {
        if (object.kind == kind && object.reason == reason) {
            object.files.append(image.file);
            return;
        }
    }
    foreign.push_back(
        {.kind = kind, .reason = reason, .identity = image.identity, .files = {image.file}});
}

bool near(const glm::dvec3& a, const glm::dvec3& b)
{
    constexpr double tolerance = 1e-4;
    return std::abs(a.x - b.x) < tolerance && std::abs(a.y - b.y) < tolerance
        && std::abs(a.z - b.z) < tolerance;
}

bool near(double a, double b)
{
    return std::abs(a - b) <= 1e-4 * std::max(std::abs(a), std::abs(b));
}

bool sameStack(const ImageHeader& a, const ImageHeader& b)
{
    return a.layout.rows == b.layout.rows && a.layout.columns == b.layout.columns
        && near(a.spacing->x, b.spacing->x) && near(a.spacing->y, b.spacing->y)
        && near(a.plane->row, b.plane->row) && near(a.plane->column, b.plane->column);
}

std::vector<Images> splitByPlane(Images images)
{
    std::vector<Images> groups;
    for (ImageHeader& image : images) {
        const auto found = std::find_if(groups.begin(), groups.end(),
            [&](const Images& group) { return sameStack(group.front(), image); });
        if (found != groups.end())
            found->push_back(std::move(image));
        else
            groups.emplace_back().push_back(std::move(image));
    }
    return groups;
}

/// Some de-identified series give every image a frame of reference of its own; that says nothing.
bool framesAreMeaningless(const Images& group)
{
    std::set<QString> frames;
    for (const ImageHeader& image : group)
        frames.insert(image.identity.frameOfReferenceUid);
    return frames.size() > 1 && frames.size() == group.size();
}

std::vector<Images> splitByFrameOfReference(Images group)
{
    std::vector<Images> groups;
    if (framesAreMeaningless(group)) {
        groups.push_back(std::move(group));
        return groups;
    }
    std::map<QString, Images> byFrame;
    for (ImageHeader& image : group)
        byFrame[image.identity.frameOfReferenceUid].push_back(std::move(image));
    for (auto& [uid, images] : byFrame)
        groups.push_back(std::move(images));
    return groups;
}

std::vector<Place> sortIntoPlaces(Images images)
{
    // Scanners round positions; slices of micro-CT may be closer than their rounding.
    const glm::dvec2 pixel = *images.front().spacing;
    const double samePlaceMm = std::min(0.01, 0.05 * std::min(pixel.x, pixel.y));
    const glm::dvec3 normal = images.front().plane->normal();
    const auto along = [&](const ImageHeader& image) { return glm::dot(*image.position, normal); };
    std::stable_sort(images.begin(), images.end(),
        [&](const ImageHeader& a, const ImageHeader& b) { return along(a) < along(b); });
    std::vector<Place> places;
    for (ImageHeader& image : images) {
        const double here = along(image);
        if (places.empty() || here - places.back().along > samePlaceMm)
            places.push_back({.along = here});
        places.back().images.push_back(std::move(image));
    }
    return places;
}

QByteArray fileHash(const QString& path)
{
    QFile file(path);
    QCryptographicHash hash(QCryptographicHash::Sha256);
    if (!file.open(QIODevice::ReadOnly) || !hash.addData(&file))
        return {};
    return hash.result();
}

/// Drops images that are at the same place under the same UID, or byte for byte the same.
void dropDuplicates(std::vector<Place>& places, std::vector<VolumeProblem>& problems)
{
    int equal = 0;
    QStringList contradicting;
    for (Place& place : places) {
        Images kept;
        for (ImageHeader& image : place.images) {
            const auto twin = std::find_if(kept.begin(), kept.end(), [&](const ImageHeader& other) {
                if (image.sopInstanceUid != other.sopInstanceUid)
                    return false;
                return !image.sopInstanceUid.isEmpty()
                    || fileHash(image.file) == fileHash(other.file);
            });
            if (twin == kept.end()) {
                kept.push_back(std::move(image));
                continue;
            }
            if (fileHash(image.file) == fileHash(twin->file))
                ++equal;
            else
                contradicting.append(QFileInfo(image.file).fileName());
        }
        place.images = std::move(kept);
    }
    if (equal > 0) {
        problems.push_back({.kind = VolumeProblem::Kind::DuplicateSlices,
            .text = equal == 1 ? QStringLiteral("1 duplicate file was left out.")
                               : QStringLiteral("%1 duplicate files were left out.").arg(equal)});
    }
    if (!contradicting.isEmpty()) {
        problems.push_back({.kind = VolumeProblem::Kind::DuplicateSlices,
            .text = QStringLiteral("Files with the identity of another but other content were left "
                                   "out: %1.")
                        .arg(contradicting.join(QLatin1String(", "))),
            .caution = true});
    }
}

/// Values of one phase attribute over all places, if it tells the images of each place apart.
struct PhaseSplit {
    QString attribute;
    std::vector<QString> values; ///< in order
    std::size_t index = 0;
};

bool lessValue(const QString& a, const QString& b)
{
    const QByteArray first = a.toLatin1();
    const QByteArray second = b.toLatin1();
    const std::optional<double> x = dicomNumber({first.constData(), std::size_t(first.size())});
    const std::optional<double> y = dicomNumber({second.constData(), std::size_t(second.size())});
    return x && y && *x != *y ? *x < *y : a < b;
}

std::optional<PhaseSplit> findPhases(const std::vector<Place>& places, std::size_t most)
{
    const std::size_t attributes = phaseAttributeNames().size();
    for (std::size_t index = 0; index < attributes; ++index) {
        std::set<QString> all;
        bool distinct = true;
        for (const Place& place : places) {
            std::set<QString> here;
            for (const ImageHeader& image : place.images)
                here.insert(image.phases.at(index));
            distinct = distinct && here.size() == place.images.size() && !here.count(QString());
            all.insert(here.begin(), here.end());
        }
        if (!distinct || all.size() != most)
            continue;
        PhaseSplit split{.attribute = phaseAttributeNames()[index],
            .values = {all.begin(), all.end()},
            .index = index};
        std::sort(split.values.begin(), split.values.end(), lessValue);
        return split;
    }
    return std::nullopt;
}

/// Images that share their places with others become one stack per phase.
void splitPhases(std::vector<Place> places, const std::vector<VolumeProblem>& problems,
    std::vector<SliceStack>& stacks)
{
    std::size_t most = 0;
    std::size_t fewest = SIZE_MAX;
    for (const Place& place : places) {
        most = std::max(most, place.images.size());
        fewest = std::min(fewest, place.images.size());
    }
    const std::optional<PhaseSplit> split = findPhases(places, most);
    for (std::size_t phase = 0; phase < most; ++phase) {
        Images images;
        for (Place& place : places) {
            if (split) {
                const auto found = std::find_if(
                    place.images.begin(), place.images.end(), [&](const ImageHeader& image) {
                        return image.phases[split->index] == split->values[phase];
                    });
                if (found != place.images.end())
                    images.push_back(*found);
                continue;
            }
            if (phase == 0) {
                std::stable_sort(place.images.begin(), place.images.end(),
                    [](const ImageHeader& a, const ImageHeader& b) {
                        return a.instanceNumber < b.instanceNumber;
                    });
            }
            if (phase < place.images.size())
                images.push_back(place.images[phase]);
        }
        SliceStack stack = stackOf(std::move(images));
        const QString which = split
            ? QStringLiteral("%1 %2").arg(split->attribute, split->values[phase])
            : QStringLiteral("by instance number");
        stack.part = QStringLiteral("%1 of %2 (%3)").arg(phase + 1).arg(most).arg(which);
        stack.problems.insert(stack.problems.begin(), problems.begin(), problems.end());
        const bool doubtful = !split || fewest != most;
        stack.problems.push_back({.kind = VolumeProblem::Kind::MixedSlices,
            .text = fewest == most
                ? QStringLiteral("%1 images lie at every position; this is %2.")
                      .arg(most)
                      .arg(stack.part)
                : QStringLiteral("%1 to %2 images lie at one position; this is %3.")
                      .arg(fewest)
                      .arg(most)
                      .arg(stack.part),
            .caution = doubtful});
        stacks.push_back(std::move(stack));
    }
}

void stackGroup(Images group, StackSorting& sorting)
{
    std::vector<VolumeProblem> problems;
    QStringList cut;
    Images sound;
    for (ImageHeader& image : group) {
        if (image.pixelsCut)
            cut.append(QFileInfo(image.file).fileName());
        else
            sound.push_back(std::move(image));
    }
    if (!cut.isEmpty())
        problems.push_back(damagedSlices(cut));
    if (sound.empty())
        return;
    if (framesAreMeaningless(sound)) {
        problems.push_back({.kind = VolumeProblem::Kind::Other,
            .text =
                QStringLiteral("Every slice names a frame of reference of its own; they are taken "
                               "as one.")});
    }
    std::vector<Place> places = sortIntoPlaces(std::move(sound));
    dropDuplicates(places, problems);

    const bool single = std::all_of(
        places.begin(), places.end(), [](const Place& place) { return place.images.size() == 1; });
    if (!single) {
        splitPhases(std::move(places), problems, sorting.stacks);
        return;
    }
    Images slices;
    for (Place& place : places)
        slices.push_back(std::move(place.images.front()));
    SliceStack stack = stackOf(std::move(slices));
    stack.problems.insert(stack.problems.begin(), problems.begin(), problems.end());
    sorting.stacks.push_back(std::move(stack));
}

} // namespace

SliceStack stackOf(std::vector<ImageHeader> slices)
{
    SliceStack stack;
    stack.slices = std::move(slices);
    placeSlices(stack);
    const bool lossy = std::any_of(stack.slices.begin(), stack.slices.end(),
        [](const ImageHeader& image) { return image.isLossy; });
    if (lossy) {
        stack.problems.push_back({.kind = VolumeProblem::Kind::LossyCompression,
            .text = QStringLiteral("The images were compressed with loss.")});
    }
    return stack;
}

StackSorting sortIntoStacks(std::vector<ImageHeader> images)
{
    StackSorting sorting;
    std::sort(images.begin(), images.end(),
        [](const ImageHeader& a, const ImageHeader& b) { return a.file < b.file; });
    Images placed;
    for (ImageHeader& image : images) {
        QString reason;
        const QString kind = apartKind(image, reason);
        if (kind.isEmpty())
            placed.push_back(std::move(image));
        else
            putApart(sorting.foreign, image, kind, reason);
    }
    for (Images& plane : splitByPlane(std::move(placed))) {
        for (Images& group : splitByFrameOfReference(std::move(plane)))
            stackGroup(std::move(group), sorting);
    }

    // Positions that wander sideways are no grid, whatever the affine says.
    std::vector<SliceStack> straight;
    for (SliceStack& stack : sorting.stacks) {
        const double drift = sidewaysDriftMm(stack);
        const double pixel = std::max(stack.slices[0].spacing->x, stack.slices[0].spacing->y);
        if (drift <= pixel) {
            straight.push_back(std::move(stack));
            continue;
        }
        for (const ImageHeader& image : stack.slices) {
            putApart(sorting.foreign, image, QStringLiteral("images that are no stack"),
                QStringLiteral("their positions wander sideways by %1 mm").arg(drift, 0, 'f', 1));
        }
    }
    sorting.stacks = std::move(straight);

    if (sorting.stacks.size() > 1) {
        for (std::size_t index = 0; index < sorting.stacks.size(); ++index) {
            QString& part = sorting.stacks[index].part;
            if (part.isEmpty())
                part = QStringLiteral("part %1 of %2").arg(index + 1).arg(sorting.stacks.size());
        }
    }
    return sorting;
}

} // namespace core
