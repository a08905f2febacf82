package mien;

// Written by abi/generate_bindings.py.
/**
 * Which algorithm finds the latent variables; with one score both give the same regression. Plain numbers:
 * newer libraries may have more.
 */
public final class Pls {
    private Pls() {}

    public static final int NIPALS = 0;

    public static final int SIMPLS = 1;
}
