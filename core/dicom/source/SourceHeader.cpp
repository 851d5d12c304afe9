// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/source/SourceHeader.h"

#include "core/dicom/source/PatientAndPlane.h"
#include "core/dicom/source/VisitSourceFiles.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace core {

Result<std::vector<SourceHeader>> readSourceHeaders(
    const std::vector<SourceSlice>& slices, const KeptHeaders* kept, const Progress& progress)
{
    std::vector<SourceHeader> headers(slices.size());
    const Result<void> visited = visitSourceFiles(slices, kept, progress,
        [&](const QString& file, DcmDataset& dataset,
            const std::vector<std::size_t>& held) -> Result<void> {
            const ItemReader reader(&dataset);
            SourceHeader common;
            common.patient = readHeaderPatient(dataset);
            common.studyUid = reader.text(DCM_StudyInstanceUID);
            common.seriesUid = reader.text(DCM_SeriesInstanceUID);
            common.frameOfReferenceUid = reader.text(DCM_FrameOfReferenceUID);
            common.sopInstanceUid = reader.text(DCM_SOPInstanceUID);
            common.rows = reader.integer(DCM_Rows).value_or(0);
            common.columns = reader.integer(DCM_Columns).value_or(0);
            for (const std::size_t k : held) {
                const auto plane = readHeaderPlane(reader, slices[k].frame);
                if (!plane)
                    return failure(ErrorCode::InvalidGeometry, file,
                        Clause::saying("position, orientation or pixel spacing is missing"));
                headers[k] = common;
                headers[k].plane = *plane;
            }
            return {};
        });
    if (!visited)
        return tl::unexpected(visited.error());
    return headers;
}

} // namespace core
