/* Mien: registers 3D face scans, removes facial expressions, measures what changed.
 *
 * Lengths are millimetres, volumes millilitres, +x is the subject's left, +y up, +z out of the
 * face. Every function that can fail returns a mien_status and fills an optional mien_error. */
#ifndef MIEN_MIEN_H
#define MIEN_MIEN_H

#include "anthropometry.h"
#include "asymmetry.h"
#include "batch.h"
#include "blendshapes.h"
#include "config.h"
#include "dataset.h"
#include "error.h"
#include "evaluation.h"
#include "expression.h"
#include "follow.h"
#include "geodesic.h"
#include "hierarchy.h"
#include "landmarks.h"
#include "measure.h"
#include "mesh.h"
#include "mesh_tools.h"
#include "model.h"
#include "model_fit.h"
#include "network.h"
#include "neutralization.h"
#include "registration.h"
#include "representation.h"
#include "score.h"
#include "series.h"
#include "session.h"
#include "spectral.h"
#include "study.h"
#include "template_check.h"
#include "training.h"
#include "visits.h"

#endif
