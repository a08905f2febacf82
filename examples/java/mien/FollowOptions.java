package mien;

// Written by abi/generate_bindings.py.
/** mien_follow_options of the C interface. */
public final class FollowOptions implements Record_ {
    private int rounds;
    private int maxVertices;
    private int maxScalarModes;
    private int maxPcaModes;
    private double temporalMm;
    private double sigmaStartMm;
    private double sigmaEndMm;
    private double lostShare;
    private double unitToMm;
    private double focalX;
    private double focalY;
    private double centreX;
    private double centreY;

    /** With the library's defaults. */
    public FollowOptions() {
        try (Call call = new Call()) {
            Memory at = call.room(96);
            int offset = 0;
            Raw.GET.mien_follow_options_init(at.address, 96);
            rounds = at.bytes.getInt(offset + 4);
            maxVertices = at.bytes.getInt(offset + 8);
            maxScalarModes = at.bytes.getInt(offset + 12);
            maxPcaModes = at.bytes.getInt(offset + 16);
            temporalMm = at.bytes.getDouble(offset + 24);
            sigmaStartMm = at.bytes.getDouble(offset + 32);
            sigmaEndMm = at.bytes.getDouble(offset + 40);
            lostShare = at.bytes.getDouble(offset + 48);
            unitToMm = at.bytes.getDouble(offset + 56);
            focalX = at.bytes.getDouble(offset + 64);
            focalY = at.bytes.getDouble(offset + 72);
            centreX = at.bytes.getDouble(offset + 80);
            centreY = at.bytes.getDouble(offset + 88);
        }
    }

    /** of closest places and a solve, per frame, 1 to 100; default 3 */
    public FollowOptions rounds(int value) {
        rounds = value;
        return this;
    }
    public int rounds() { return rounds; }

    /** of the template that pull, 100 or more; default 2500 */
    public FollowOptions maxVertices(int value) {
        maxVertices = value;
        return this;
    }
    public int maxVertices() { return maxVertices; }

    /** of the model's kernel modes that move, 0 or more; default 250 */
    public FollowOptions maxScalarModes(int value) {
        maxScalarModes = value;
        return this;
    }
    public int maxScalarModes() { return maxScalarModes; }

    /** of the model's trained modes that move, 0 or more; default 60 */
    public FollowOptions maxPcaModes(int value) {
        maxPcaModes = value;
        return this;
    }
    public int maxPcaModes() { return maxPcaModes; }

    /**
     * deviation of a vertex from where it was on the head in the frame before; 0: frames know nothing of each
     * other; default 4
     */
    public FollowOptions temporalMm(double value) {
        temporalMm = value;
        return this;
    }
    public double temporalMm() { return temporalMm; }

    /** noise level of a surface point in a frame's first round; default 1.5 */
    public FollowOptions sigmaStartMm(double value) {
        sigmaStartMm = value;
        return this;
    }
    public double sigmaStartMm() { return sigmaStartMm; }

    /** and in its last; default 0.7 */
    public FollowOptions sigmaEndMm(double value) {
        sigmaEndMm = value;
        return this;
    }
    public double sigmaEndMm() { return sigmaEndMm; }

    /** the face is lost when less of it lies on what the camera sees; 0 to 1, default 0.5 */
    public FollowOptions lostShare(double value) {
        lostShare = value;
        return this;
    }
    public double lostShare() { return lostShare; }

    /** one unit of the frames' points in mm; default 1 */
    public FollowOptions unitToMm(double value) {
        unitToMm = value;
        return this;
    }
    public double unitToMm() { return unitToMm; }

    /** pixels, column = focal_x x / z + centre_x; 0 (default): all four are found from each frame's points */
    public FollowOptions focalX(double value) {
        focalX = value;
        return this;
    }
    public double focalX() { return focalX; }

    /** pixels, row = focal_y y / z + centre_y */
    public FollowOptions focalY(double value) {
        focalY = value;
        return this;
    }
    public double focalY() { return focalY; }

    /** pixels */
    public FollowOptions centreX(double value) {
        centreX = value;
        return this;
    }
    public double centreX() { return centreX; }

    /** pixels */
    public FollowOptions centreY(double value) {
        centreY = value;
        return this;
    }
    public double centreY() { return centreY; }

    @Override
    public void fill(Call call, Memory at, int offset) {
        Raw.GET.mien_follow_options_init(at.address + offset, 96);
        at.bytes.putInt(offset + 4, rounds);
        at.bytes.putInt(offset + 8, maxVertices);
        at.bytes.putInt(offset + 12, maxScalarModes);
        at.bytes.putInt(offset + 16, maxPcaModes);
        at.bytes.putDouble(offset + 24, temporalMm);
        at.bytes.putDouble(offset + 32, sigmaStartMm);
        at.bytes.putDouble(offset + 40, sigmaEndMm);
        at.bytes.putDouble(offset + 48, lostShare);
        at.bytes.putDouble(offset + 56, unitToMm);
        at.bytes.putDouble(offset + 64, focalX);
        at.bytes.putDouble(offset + 72, focalY);
        at.bytes.putDouble(offset + 80, centreX);
        at.bytes.putDouble(offset + 88, centreY);
    }
}
