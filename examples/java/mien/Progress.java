package mien;

/** Called on the calling thread; false cancels. What it throws comes out of the call that was running. */
@FunctionalInterface
public interface Progress {
    /** A stage of the work (see Stage), and a fraction of 0 to 1 that never falls within a stage. */
    boolean report(int stage, double fraction);
}
