// SPDX-License-Identifier: Apache-2.0
#pragma once

// Every edit with its fields (schema/SchemaParts.h says how they are shown to a visitor).

#include "core/edits/schema/ChunkSchema.h"
#include "core/edits/schema/GrowthSchema.h"
#include "core/edits/schema/HistorySchema.h"
#include "core/edits/schema/LayerSchema.h"
#include "core/edits/schema/PieceSchema.h"
#include "core/edits/schema/SculptSchema.h"
#include "core/edits/schema/SegmentSchema.h"
#include "core/edits/schema/SurfaceSchema.h"
#include "core/edits/schema/ViewSchema.h"
