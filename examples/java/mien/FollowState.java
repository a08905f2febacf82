package mien;

// Written by abi/generate_bindings.py.
/**
 * What is told of a frame.
 * @param state MIEN_FOLLOW_* See Follow.
 * @param share 0 to 1: of the vertices that face the camera, those on the surface
 * @param residualMm mean distance of these from it
 * @param slideMm median way of the vertices along the skin since the start: expressions move a part of a
 * face, sliding moves most of it
 */
public record FollowState(int state, double share, double residualMm, double slideMm) {

    static FollowState read(Call call, Memory at, int offset) {
        return new FollowState(
            at.bytes.getInt(offset + 4),
            at.bytes.getDouble(offset + 8),
            at.bytes.getDouble(offset + 16),
            at.bytes.getDouble(offset + 24));
    }
}
