// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/SegmentLayers.h"

#include "core/edits/document/DocumentEdits.h"
#include "core/edits/kinds/segments/LayerToSegment.h"

#include <algorithm>

namespace core {

std::map<int, int> layersOfSegments(const History& history, const Document& document)
{
    const std::vector<RowId> standing = history.standing();
    const auto stands = [&standing](RowId row) {
        return std::find(standing.begin(), standing.end(), row) != standing.end();
    };
    std::map<int, int> layers;
    // A new segment's label is that of its time: the rows tell it when they are counted again.
    Document then = initialDocument({});
    for (const RowId id : history.pathTo(history.position())) {
        const Edit& edit = history.row(id).edit;
        static_cast<void>(applyToDocument(edit, then));
        const auto* made = edit.as<LayerToSegment>();
        if (made && stands(id))
            layers[made->target.segment.value_or(then.lastLabelGiven())] = made->layer;
    }
    std::erase_if(layers, [&document](const auto& each) {
        return !document.segment(each.first) || !document.layer(each.second);
    });
    return layers;
}

} // namespace core
