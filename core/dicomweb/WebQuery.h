// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicomweb/WebNode.h"
#include "core/pacs/PacsQuery.h"

namespace core {

/// Whether the server answers a DICOMweb request. Errors of all functions here: those of
/// WebConnection, and NodeNonsense. They block; call them on a worker thread.
[[nodiscard]] Result<void> echoNode(const WebNode& node, const Progress& progress);

/// The same as for a DICOM node, by QIDO-RS.
[[nodiscard]] Result<HitList<StudyHit>> findStudies(
    const WebNode& node, const StudyFilter& filter, int most, const Progress& progress);
[[nodiscard]] Result<std::vector<SeriesHit>> findSeries(
    const WebNode& node, const QString& studyUid, const Progress& progress);
[[nodiscard]] Result<std::vector<InstanceHit>> findInstances(const WebNode& node,
    const QString& studyUid, const QString& seriesUid, const Progress& progress);

/// Whether a text can be a UID; only such texts are put into addresses.
[[nodiscard]] bool isDicomUid(const QString& text);

} // namespace core
