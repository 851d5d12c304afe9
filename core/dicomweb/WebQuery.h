// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicomweb/WebNode.h"
#include "core/pacs/PacsQuery.h"

namespace core {

/// Whether the server answers a question of DICOMweb. Errors of all these: as of WebConnection, and
/// NodeNonsense. They wait for the network; call them on a worker's thread.
[[nodiscard]] Result<void> echoNode(const WebNode& node, const Progress& progress);

/// As of a DICOM node, by QIDO-RS.
[[nodiscard]] Result<HitList<StudyHit>> findStudies(
    const WebNode& node, const StudyFilter& filter, int most, const Progress& progress);
[[nodiscard]] Result<std::vector<SeriesHit>> findSeries(
    const WebNode& node, const QString& studyUid, const Progress& progress);
[[nodiscard]] Result<std::vector<InstanceHit>> findInstances(const WebNode& node,
    const QString& studyUid, const QString& seriesUid, const Progress& progress);

/// Whether a text can be a UID: nothing else gets into an address.
[[nodiscard]] bool isDicomUid(const QString& text);

} // namespace core
