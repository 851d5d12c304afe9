// SPDX-License-Identifier: Apache-2.0
#include "tests/support/WorkspaceFixture.h"

#include "ui/ErrorText.h"

#include <utility>

namespace test {

namespace smallHead {

namespace {

const glm::dvec3 spacing(1.0, 1.0, 1.5);
constexpr int middle = side / 2;

double valueAt(int i, int j, int k)
{
    const double distance = glm::length(glm::dvec3(i - middle, j - middle, k - middle) * spacing);
    return distance < 5.0 ? ventricleHu
        : distance < 13.0 ? brainHu
        : distance < 16.0 ? boneHu
                          : airHu;
}

} // namespace

core::LoadedVolume volume()
{
    core::LoadedVolume loaded;
    core::Volume& volume = loaded.volume;
    volume.identity.patientName = QStringLiteral("TEST^SMALL HEAD");
    volume.identity.patientId = QStringLiteral("T-1");
    volume.identity.birthDate = QStringLiteral("1961-02-03");
    volume.identity.studyDate = QStringLiteral("2026-11-20");
    volume.identity.modality = QStringLiteral("CT");
    volume.geometry.size = glm::ivec3(side);
    for (int axis = 0; axis < 3; ++axis) {
        volume.geometry.indexToWorld[axis][axis] = spacing[axis];
        volume.geometry.indexToWorld[3][axis] = -middle * spacing[axis];
    }
    volume.encoding.rescaleIntercept = -1024.0;
    volume.unit = QStringLiteral("HU");
    volume.minimum = airHu;
    volume.maximum = boneHu;
    volume.histogram = {airHu, boneHu, std::vector<std::uint32_t>(128, 0)};
    loaded.codes.reserve(volume.geometry.voxelCount());
    for (int k = 0; k < side; ++k) {
        for (int j = 0; j < side; ++j) {
            for (int i = 0; i < side; ++i) {
                const double value = valueAt(i, j, k);
                loaded.codes.push_back(std::uint16_t(value + 1024.0));
                const double bin = (value - airHu) / (boneHu - airHu) * 127.0;
                ++volume.histogram.counts[std::size_t(bin)];
            }
        }
    }
    return loaded;
}

std::int64_t voxelsOf(double hu)
{
    std::int64_t count = 0;
    for (int k = 0; k < side; ++k) {
        for (int j = 0; j < side; ++j) {
            for (int i = 0; i < side; ++i)
                count += valueAt(i, j, k) == hu;
        }
    }
    return count;
}

} // namespace smallHead

WorkspaceFixture::WorkspaceFixture(core::LoadedVolume volume)
    : workspace(frames)
{
    auto session = core::EditSession::create(engine, std::move(volume), {});
    if (!session)
        qFatal("%s", qPrintable(ui::errorText(session.error())));
    workspace.setSession(std::move(*session));
}

void WorkspaceFixture::apply(const core::Edit& edit)
{
    if (const auto applied = session().apply(edit); !applied)
        qFatal("%s", qPrintable(ui::errorText(applied.error())));
    settle();
}

void WorkspaceFixture::settle()
{
    if (const auto settled = session().settle(); !settled)
        qFatal("%s", qPrintable(ui::errorText(settled.error())));
}

core::SeedStroke WorkspaceFixture::middleSeed(int segment)
{
    return {segment, {glm::dvec3(0.0)}};
}

} // namespace test
